using System.Collections.Generic;
using System.Linq;
using System.Xml.Linq;
using Nowpose.Messages;

namespace Nowpose.Kinematics
{
    /// <summary>A link of the URDF, before it has a place in the tree.</summary>
    sealed class UrdfLink
    {
        readonly UrdfSource _source;
        readonly UrdfMaterials _materials;

        public UrdfLink(UrdfSource source, XElement element, UrdfMaterials materials)
        {
            _source = source;
            _materials = materials;
            Element = element;
            Name = source.RequiredName(element, "name");
            Visuals = element.Elements(element.Name.Namespace + "visual").Select(Visual).Where(v => v != null).ToArray();
        }

        public XElement Element { get; }
        public string Name { get; }
        public IReadOnlyList<LinkVisual> Visuals { get; }

        // An unknown shape is not drawn; the robot still moves.
        LinkVisual Visual(XElement visual)
        {
            var shape = UrdfSource.Child(visual, "geometry")?.Elements().FirstOrDefault();
            switch (shape?.Name.LocalName)
            {
                case "box": return Make(VisualShape.Box, Size(shape));
                case "cylinder": return Make(VisualShape.Cylinder, (Diameter(shape), Diameter(shape), Length(shape, "length")));
                case "sphere": return Make(VisualShape.Sphere, (Diameter(shape), Diameter(shape), Diameter(shape)));
                case "mesh":
                    var file = _source.RequiredName(shape, "filename");
                    return Make(VisualShape.Mesh, _source.Triple(shape, "scale", (1, 1, 1)), file);
                default: return null;
            }

            LinkVisual Make(VisualShape kind, (double, double, double) size, string meshFile = null) =>
                new LinkVisual(kind, _source.Origin(visual), size, meshFile, _materials.ColourOf(visual));
        }

        (double X, double Y, double Z) Size(XElement box)
        {
            var size = _source.Triple(box, "size", (double.NaN, 0, 0));
            if (double.IsNaN(size.X)) throw _source.Error(box, UrdfMessages.AttributeMissing("size"));
            if (!(size.X >= 0 && size.Y >= 0 && size.Z >= 0)) throw _source.Error(box, UrdfMessages.BoxSize(size.X, size.Y, size.Z));
            return size;
        }

        double Diameter(XElement shape) => 2 * Length(shape, "radius");

        double Length(XElement shape, string attribute)
        {
            var length = _source.Number(shape, attribute, double.NaN);
            if (double.IsNaN(length)) throw _source.Error(shape, UrdfMessages.AttributeMissing(attribute));
            if (!(length >= 0)) throw _source.Error(shape, UrdfMessages.Length(attribute, length));
            return length;
        }
    }
}
