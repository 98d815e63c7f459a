using System;
using System.Text;

namespace Nowpose.Recording
{
    /// <summary>Names of an enumeration's members in session files: lower case, words joined by underscores.</summary>
    /// <remarks>Created once, because <see cref="Enum.ToString()"/> allocates. Supports enumerations whose values count from 0.</remarks>
    sealed class LineNames
    {
        readonly string[] _names;

        public LineNames(Type enumeration) => _names = Array.ConvertAll(Enum.GetNames(enumeration), Snake);

        public int Count => _names.Length;

        public string this[int value] => _names[value];

        static string Snake(string name)
        {
            var text = new StringBuilder();
            foreach (var c in name)
            {
                if (char.IsUpper(c) && text.Length > 0) text.Append('_');
                text.Append(char.ToLowerInvariant(c));
            }
            return text.ToString();
        }
    }
}
