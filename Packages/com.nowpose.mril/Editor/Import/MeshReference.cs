using System.Collections.Generic;

namespace Nowpose.Editor.Import
{
    /// <summary>The path of a mesh that a URDF refers to, or the paths at which the mesh was not found.</summary>
    sealed class MeshReference
    {
        public MeshReference(string path, IReadOnlyList<string> candidates, string fault)
        {
            Path = path;
            Candidates = candidates;
            Fault = fault;
        }

        /// <summary>Path within the project, starting with Assets or Packages; null if the file was not found.</summary>
        public string Path { get; }

        /// <summary>All paths that were tried. If a file is added at one of them, the URDF must be imported again.</summary>
        public IReadOnlyList<string> Candidates { get; }

        /// <summary>Reason why the file was not found, with a remedy; null if it was found.</summary>
        public string Fault { get; }
    }
}
