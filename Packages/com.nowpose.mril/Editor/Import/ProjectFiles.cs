using System.IO;

namespace Nowpose.Editor.Import
{
    /// <summary>Maps asset paths to files. The editor's working folder is the project; it maps Packages/NAME to the package's folder.</summary>
    static class ProjectFiles
    {
        public static string FullPath(string assetPath) => Path.GetFullPath(assetPath);

        public static MeshLocator LocatorFor(string urdfPath) =>
            new MeshLocator(urdfPath, Directory.GetCurrentDirectory(), path => File.Exists(FullPath(path)));
    }
}
