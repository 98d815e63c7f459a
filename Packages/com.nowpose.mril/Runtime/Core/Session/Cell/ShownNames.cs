using System;
using System.Collections.Generic;

namespace Nowpose.Session.Cell
{
    /// <summary>Names of the parts that are shown, with the number of components that show each of them.</summary>
    sealed class ShownNames
    {
        readonly Dictionary<string, int> _counts = new Dictionary<string, int>(StringComparer.Ordinal);

        public IReadOnlyCollection<string> All => _counts.Keys;

        public bool Contains(string name) => _counts.ContainsKey(name);

        /// <summary>Adds one component that shows the part.</summary>
        public void Add(string name)
        {
            _counts.TryGetValue(name, out var count);
            _counts[name] = count + 1;
        }

        /// <summary>Reverses one <see cref="Add"/>.</summary>
        /// <returns>True if no component shows the part any more.</returns>
        public bool Remove(string name)
        {
            if (!_counts.TryGetValue(name, out var count)) return false;
            if (count == 1) return _counts.Remove(name);
            _counts[name] = count - 1;
            return false;
        }
    }
}
