using System.Collections.Generic;

namespace Nowpose.Editor.Import
{
    /// <summary>Where a URDF's mesh is, or could be.</summary>
    sealed class MeshReference
    {
        public MeshReference(string path, IReadOnlyList<string> candidates, string fault)
        {
            Path = path;
            Candidates = candidates;
            Fault = fault;
        }

        /// <summary>Path within the project, from Assets or Packages; null where there is none.</summary>
        public string Path { get; }

        /// <summary>Every path that was tried: a file that comes to lie there later changes the import.</summary>
        public IReadOnlyList<string> Candidates { get; }

        /// <summary>Why there is none, and what to do; null where there is.</summary>
        public string Fault { get; }
    }
}
