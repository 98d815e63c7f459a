using System.Collections.Generic;

namespace Nowpose.Editor.Import
{
    /// <summary>The path of a URDF's mesh, or the paths at which it was not found.</summary>
    sealed class MeshReference
    {
        public MeshReference(string path, IReadOnlyList<string> candidates, string fault)
        {
            Path = path;
            Candidates = candidates;
            Fault = fault;
        }

        /// <summary>Path within the project, from Assets or Packages; null if the file was not found.</summary>
        public string Path { get; }

        /// <summary>All paths that were tried: the import changes when a file is added at one of them.</summary>
        public IReadOnlyList<string> Candidates { get; }

        /// <summary>Why the file was not found, and what to do; null if it was found.</summary>
        public string Fault { get; }
    }
}
