using System.IO;
using System.Runtime.CompilerServices;
using Nowpose.Kinematics;

namespace Nowpose.Tests.Core.Kinematics
{
    /// <summary>Reads the robots of the package and the URDF files of the tests. The paths are relative to this source file.</summary>
    static class UrdfFiles
    {
        public static RobotModel Robot(string name) => UrdfReader.Read(Text(name + ".urdf"), name + ".urdf");

        public static string Text(string file)
        {
            var own = Path.Combine(Here(), file);
            return File.ReadAllText(File.Exists(own) ? own : Path.Combine(Here(), "..", "..", "..", "..", "Runtime", "Robots", file));
        }

        static string Here([CallerFilePath] string here = "") => Path.GetDirectoryName(here);

        /// <summary>Reads a robot with one element per line. The first line of <paramref name="body"/> is line 2.</summary>
        public static RobotModel Read(string body) => UrdfReader.Read("<robot name='r'>\n" + body + "\n</robot>", "r.urdf");

        public static string Links(params string[] names) => "<link name='" + string.Join("'/><link name='", names) + "'/>";

        public static string Joint(string name, string parent, string child, string type = "revolute", string inside = "") =>
            "<joint name='" + name + "' type='" + type + "'><parent link='" + parent + "'/><child link='" + child + "'/>"
            + inside + "</joint>";
    }
}
