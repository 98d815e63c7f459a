using System;
using System.Linq;
using System.Xml.Linq;
using Nowpose.Messages;

namespace Nowpose.Kinematics
{
    /// <summary>Reads robots in the Unified Robot Description Format of ROS.</summary>
    /// <remarks>
    /// Supports links with their visuals; fixed, revolute, continuous and prismatic joints; mimic and limits. Ignores all other elements
    /// (collision, inertia, transmissions, gazebo). Rejects document type declarations and entities.
    /// </remarks>
    public static class UrdfReader
    {
        /// <param name="text">The whole document, with xacro already expanded.</param>
        /// <param name="sourceName">Name in error messages, usually the file name.</param>
        /// <exception cref="InputException">
        /// The text does not describe a robot whose kinematics can be computed; the message names the line, the element and the error.
        /// </exception>
        public static RobotModel Read(string text, string sourceName)
        {
            var source = new UrdfSource(sourceName);
            var root = source.ParseRoot(text);
            if (root.Name.LocalName != "robot")
                throw source.Error(root, UrdfMessages.Root);
            // The namespace of xacro has had several addresses, all with this end.
            var macro = root.Descendants().FirstOrDefault(element => element.Name.NamespaceName.EndsWith("/xacro", StringComparison.Ordinal));
            if (macro != null)
                throw source.Error(macro, UrdfMessages.Xacro);

            var materials = new UrdfMaterials(source, root);
            var links = Children(root, "link").Select(e => new UrdfLink(source, e, materials)).ToArray();
            var joints = UrdfJoint.ReadAll(source, Children(root, "joint"));
            var tree = new UrdfTree(source, root, links, joints);
            return new RobotModel(
                (string)root.Attribute("name") ?? "",
                UrdfHash.Of(text),
                tree.Links,
                joints.Select(joint => joint.Joint).ToArray(),
                UrdfMimics.InOrder(source, joints),
                tree.ToolLink(links));
        }

        static XElement[] Children(XElement root, string name) => root.Elements(root.Name.Namespace + name).ToArray();
    }
}
