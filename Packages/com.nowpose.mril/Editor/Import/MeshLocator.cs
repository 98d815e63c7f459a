using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Import
{
    /// <summary>Finds, among the assets of a Unity project, the file of a mesh that a URDF names (<c>package://NAME/PATH</c> or a path).</summary>
    /// <remarks>
    /// ROS finds a package by its manifest. A Unity project does not contain these manifests, so the name of a folder identifies the package. The
    /// search covers the folders above the URDF and the folders beside each of them, nearest first, and then Packages and Assets.
    /// </remarks>
    sealed class MeshLocator
    {
        static readonly string[] PackageSchemes = { "package://", "model://" };

        readonly string _folder;
        readonly string _projectFolder;
        readonly Func<string, bool> _exists;

        /// <param name="urdfPath">Path of the URDF within the project.</param>
        /// <param name="projectFolder">Absolute path of the project, for URDFs that contain absolute paths.</param>
        /// <param name="exists">Returns whether a file exists at a path within the project.</param>
        public MeshLocator(string urdfPath, string projectFolder, Func<string, bool> exists)
        {
            _folder = Parent(urdfPath);
            _projectFolder = projectFolder.Replace('\\', '/').TrimEnd('/') + "/";
            _exists = exists;
        }

        public MeshReference Find(string name)
        {
            var path = name.Replace('\\', '/');
            if (path.Contains("$(")) return Fault(name, MeshMessages.Xacro);
            foreach (var scheme in PackageSchemes)
                if (path.StartsWith(scheme, StringComparison.OrdinalIgnoreCase)) return InPackage(name, path.Substring(scheme.Length));
            if (path.StartsWith("file://", StringComparison.OrdinalIgnoreCase)) path = OfFileUri(path);
            else if (path.Contains("://")) return Fault(name, MeshMessages.Scheme);
            if (IsRooted(path)) return Absolute(name, path);
            var relative = Normal(_folder + "/" + path);
            return relative == null ? Outside(name) : FirstOf(name, new[] { relative });
        }

        MeshReference InPackage(string name, string path)
        {
            var slash = path.IndexOf('/');
            if (slash <= 0 || slash == path.Length - 1) return Fault(name, MeshMessages.NoFileInPackage);
            var package = path.Substring(0, slash);
            var file = path.Substring(slash + 1);
            var candidates = new List<string>();
            for (var folder = _folder; folder != ""; folder = Parent(folder))
            {
                if (LastName(folder) == package) candidates.Add(Normal(folder + "/" + file));
                candidates.Add(Normal(folder + "/" + package + "/" + file));
            }
            candidates.Add(Normal("Packages/" + package + "/" + file));
            candidates.Add(Normal("Assets/" + package + "/" + file));
            return FirstOf(name, candidates.Where(c => c != null).Distinct().ToArray());
        }

        MeshReference Absolute(string name, string path)
        {
            if (!path.StartsWith(_projectFolder, StringComparison.OrdinalIgnoreCase)) return Outside(name);
            var within = Normal(path.Substring(_projectFolder.Length));
            return within == null ? Outside(name) : FirstOf(name, new[] { within });
        }

        MeshReference FirstOf(string name, string[] candidates)
        {
            var path = candidates.FirstOrDefault(_exists);
            return path != null
                ? new MeshReference(path, candidates, null)
                : new MeshReference(null, candidates, MeshMessages.NotFound(name, string.Join(", ", candidates)));
        }

        static MeshReference Outside(string name) =>
            Fault(name, MeshMessages.Outside);

        static MeshReference Fault(string name, string fault) => new MeshReference(null, Array.Empty<string>(), "'" + name + "' " + fault);

        // Converts file:///a/b to /a/b, and file:///C:/b to C:/b.
        static string OfFileUri(string uri)
        {
            var path = uri.Substring("file://".Length);
            return path.Length > 2 && path[0] == '/' && path[2] == ':' ? path.Substring(1) : path;
        }

        static bool IsRooted(string path) => path.StartsWith('/') || path.Length > 1 && path[1] == ':';

        /// <summary>Returns the path without . and .., or null if it is outside the folders that Unity imports.</summary>
        static string Normal(string path)
        {
            var parts = new List<string>();
            foreach (var part in path.Split('/'))
            {
                if (part == "" || part == ".") continue;
                if (part != "..") parts.Add(part);
                else if (parts.Count == 0) return null;
                else parts.RemoveAt(parts.Count - 1);
            }
            return parts.Count > 1 && (parts[0] == "Assets" || parts[0] == "Packages") ? string.Join("/", parts) : null;
        }

        static string Parent(string path)
        {
            var slash = path.LastIndexOf('/');
            return slash < 0 ? "" : path.Substring(0, slash);
        }

        static string LastName(string path) => path.Substring(path.LastIndexOf('/') + 1);
    }
}
