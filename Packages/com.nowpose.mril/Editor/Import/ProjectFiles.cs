using System.IO;

namespace Nowpose.Editor.Import
{
    /// <summary>Paths of assets as files. The editor's working folder is the project, and it maps Packages/NAME to where a package is.</summary>
    static class ProjectFiles
    {
        public static string FullPath(string assetPath) => Path.GetFullPath(assetPath);

        public static MeshLocator LocatorFor(string urdfPath) =>
            new MeshLocator(urdfPath, Directory.GetCurrentDirectory(), path => File.Exists(FullPath(path)));
    }
}
