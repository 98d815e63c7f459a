using System.IO;

namespace Nowpose.Editor.Import
{
    /// <summary>Converts asset paths to file paths.</summary>
    /// <remarks>The current directory of the editor is the project. In it, the editor maps Packages/NAME to the folder of the package.</remarks>
    static class ProjectFiles
    {
        public static string FullPath(string assetPath) => Path.GetFullPath(assetPath);

        public static MeshLocator LocatorFor(string urdfPath) =>
            new MeshLocator(urdfPath, Directory.GetCurrentDirectory(), path => File.Exists(FullPath(path)));
    }
}
