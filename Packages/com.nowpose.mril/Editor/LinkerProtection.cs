using System.IO;
using UnityEditor.Build;
using UnityEditor.Build.Reporting;
using UnityEditor.UnityLinker;

namespace Nowpose.Editor
{
    /// <summary>In each build of a project with this package, passes to Unity's linker the list of the code that it must not strip.</summary>
    /// <remarks>
    /// Unity reads a link.xml only from Assets/, so a package must supply one through this interface. The assemblies:
    /// <list type="bullet">
    /// <item>Nowpose.Unity is protected. Without protection, the linker would keep the components in the scenes of a build, but strip
    /// components that occur only in an asset bundle or Addressable, and members that only a UnityEvent in such an asset calls by name. The
    /// assembly is small.</item>
    /// <item>Nowpose.ArFoundation, Nowpose.OpenXR, Nowpose.OpenXR.Anchoring and Nowpose.MRTK3 also contain components. They are protected if they
    /// exist.</item>
    /// <item>Nowpose is not protected: Nowpose.Unity and the user's code call it directly, without reflection.</item>
    /// <item>MathNet.Numerics is not protected: the package calls its regression and distributions directly, and they do not use reflection.
    /// Protection would add megabytes of code and minutes to each build.</item>
    /// <item>Newtonsoft.Json is not protected: at run time, the package uses only its token reader and writer, without reflection.</item>
    /// <item>Of System.Configuration and System, only the types are protected that Mono creates by name when the first TLS connection checks a
    /// certificate, in the static constructor of ServicePointManager. With high stripping they would be missing, and each connection would fail.
    /// </item>
    /// </list>
    /// </remarks>
    public sealed class LinkerProtection : IUnityLinkerProcessor
    {
        const string Name = "Nowpose.link.xml";

        // The attribute ignoreIfMissing is needed because the assembly for an optional package exists only if this package is installed.
        const string Content = "<linker>\n"
            + "  <assembly fullname=\"Nowpose.Unity\" preserve=\"all\"/>\n"
            + "  <assembly fullname=\"Nowpose.ArFoundation\" preserve=\"all\" ignoreIfMissing=\"1\"/>\n"
            + "  <assembly fullname=\"Nowpose.OpenXR\" preserve=\"all\" ignoreIfMissing=\"1\"/>\n"
            + "  <assembly fullname=\"Nowpose.OpenXR.Anchoring\" preserve=\"all\" ignoreIfMissing=\"1\"/>\n"
            + "  <assembly fullname=\"Nowpose.MRTK3\" preserve=\"all\" ignoreIfMissing=\"1\"/>\n"
            + "  <assembly fullname=\"System.Configuration\" ignoreIfMissing=\"1\">\n"
            + "    <type fullname=\"System.Configuration.ExeConfigurationHost\" preserve=\"all\"/>\n"
            + "  </assembly>\n"
            + "  <assembly fullname=\"System\" ignoreIfMissing=\"1\">\n"
            + "    <namespace fullname=\"System.Net.Configuration\" preserve=\"all\"/>\n"
            + "  </assembly>\n"
            + "</linker>\n";

        public int callbackOrder => 0;

        /// <summary>Writes the link.xml.</summary>
        /// <returns>Absolute path of the file. It is in the project's Temp folder, which Unity deletes when it closes.</returns>
        public string GenerateAdditionalLinkXmlFile(BuildReport report, UnityLinkerBuildPipelineData data)
        {
            var path = Path.GetFullPath(Path.Combine("Temp", Name));
            Directory.CreateDirectory(Path.GetDirectoryName(path));
            File.WriteAllText(path, Content);
            return path;
        }
    }
}
