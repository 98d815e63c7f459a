using System.IO;
using UnityEditor.Build;
using UnityEditor.Build.Reporting;
using UnityEditor.UnityLinker;

namespace Nowpose.Editor
{
    /// <summary>Tells Unity's linker, in every build of a project with this package, what it must not strip.</summary>
    /// <remarks>
    /// A link.xml counts only under Assets/, so a package has to hand one over. What is at risk, and what is not:
    /// <list type="bullet">
    /// <item>Nowpose.Unity is. The linker keeps the components that it finds in the build's scenes, but neither those that only an
    /// asset bundle or an Addressable holds, nor members that only a UnityEvent in one calls by name. The assembly is small.</item>
    /// <item>Nowpose.ArFoundation, Nowpose.OpenXR, Nowpose.OpenXR.Anchoring and Nowpose.MRTK3 are, where they exist: components, too.</item>
    /// <item>Nowpose is not: no line of it is reached by reflection, all of it from Nowpose.Unity or from the user's own code.</item>
    /// <item>MathNet.Numerics is not: its regression and its distributions are called directly and use no reflection. Keeping all
    /// of it would cost megabytes of code and minutes of each build.</item>
    /// <item>Newtonsoft.Json is not: only its token writer is used at run time, without reflection.</item>
    /// </list>
    /// </remarks>
    public sealed class LinkerProtection : IUnityLinkerProcessor
    {
        const string Name = "Nowpose.link.xml";

        // Where an optional package is missing, so is the assembly for it.
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
