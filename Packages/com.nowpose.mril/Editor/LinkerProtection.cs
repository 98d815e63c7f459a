using System.IO;
using UnityEditor.Build;
using UnityEditor.Build.Reporting;
using UnityEditor.UnityLinker;

namespace Nowpose.Editor
{
    /// <summary>Lists, for every build of a project with this package, the assemblies that Unity's linker must not strip.</summary>
    /// <remarks>
    /// Unity reads a link.xml only from Assets/, so a package has to supply one through this interface. The assemblies:
    /// <list type="bullet">
    /// <item>Nowpose.Unity is protected. The linker keeps the components that it finds in the build's scenes. It strips components
    /// that only an asset bundle or an Addressable contains, and members that only a UnityEvent in one calls by name. The assembly is small.</item>
    /// <item>Nowpose.ArFoundation, Nowpose.OpenXR, Nowpose.OpenXR.Anchoring and Nowpose.MRTK3 contain components too and are protected
    /// where they exist.</item>
    /// <item>Nowpose is not protected: Nowpose.Unity and the user's code call it directly, never by reflection.</item>
    /// <item>MathNet.Numerics is not protected: its regression and its distributions are called directly and use no reflection.
    /// Keeping all of it would cost megabytes of code and minutes of each build.</item>
    /// <item>Newtonsoft.Json is not protected: only its token writer is used at run time, without reflection.</item>
    /// </list>
    /// </remarks>
    public sealed class LinkerProtection : IUnityLinkerProcessor
    {
        const string Name = "Nowpose.link.xml";

        // The assembly for an optional package is missing if that package is not installed.
        const string Content = "<linker>\n"
            + "  <assembly fullname=\"Nowpose.Unity\" preserve=\"all\"/>\n"
            + "  <assembly fullname=\"Nowpose.ArFoundation\" preserve=\"all\" ignoreIfMissing=\"1\"/>\n"
            + "  <assembly fullname=\"Nowpose.OpenXR\" preserve=\"all\" ignoreIfMissing=\"1\"/>\n"
            + "  <assembly fullname=\"Nowpose.OpenXR.Anchoring\" preserve=\"all\" ignoreIfMissing=\"1\"/>\n"
            + "  <assembly fullname=\"Nowpose.MRTK3\" preserve=\"all\" ignoreIfMissing=\"1\"/>\n"
            + "</linker>\n";

        public int callbackOrder => 0;

        /// <returns>The absolute path of a file in the project's Temp folder, which Unity empties when it closes.</returns>
        public string GenerateAdditionalLinkXmlFile(BuildReport report, UnityLinkerBuildPipelineData data)
        {
            var path = Path.GetFullPath(Path.Combine("Temp", Name));
            Directory.CreateDirectory(Path.GetDirectoryName(path));
            File.WriteAllText(path, Content);
            return path;
        }
    }
}
