using System;
using System.Collections.Generic;
using System.Xml.Linq;
using Nowpose.Messages;

namespace Nowpose.Kinematics
{
    /// <summary>Colours by material name. A visual may define a material that other visuals use, so all materials are collected first.</summary>
    sealed class UrdfMaterials
    {
        readonly UrdfSource _source;
        readonly Dictionary<string, VisualColour> _colours = new Dictionary<string, VisualColour>(StringComparer.Ordinal);

        public UrdfMaterials(UrdfSource source, XElement root)
        {
            _source = source;
            foreach (var material in root.Descendants(root.Name.Namespace + "material"))
            {
                var name = (string)material.Attribute("name");
                if (IsRobotMaterial(material, root) && name != null && Inline(material) is VisualColour colour)
                    _colours[name] = colour;
            }
        }

        /// <summary>Returns the colour of a visual; null if it has no material or its material has no colour.</summary>
        public VisualColour? ColourOf(XElement visual)
        {
            var material = UrdfSource.Child(visual, "material");
            if (material == null) return null;
            if (Inline(material) is VisualColour colour) return colour;
            return _colours.TryGetValue((string)material.Attribute("name") ?? "", out colour) ? colour : (VisualColour?)null;
        }

        // Gazebo's own <material> elements are excluded: they contain the name of a material as text and are not URDF materials.
        static bool IsRobotMaterial(XElement material, XElement root) =>
            material.Parent == root || material.Parent.Name.LocalName == "visual" && material.Parent.Parent.Parent == root;

        VisualColour? Inline(XElement material)
        {
            var colour = UrdfSource.Child(material, "color");
            if (colour == null) return null;
            var rgba = _source.Numbers(colour, "rgba");
            if (rgba.Length != 3 && rgba.Length != 4)
                throw _source.Error(colour, UrdfMessages.Colour(rgba.Length));
            return new VisualColour(rgba[0], rgba[1], rgba[2], rgba.Length == 4 ? rgba[3] : 1);
        }
    }
}
