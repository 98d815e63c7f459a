using System;
using System.Collections.Generic;
using System.Text;

namespace Nowpose
{
    /// <summary>Names of the values of an enum in files, diagnostics and messages: lower case, words joined by underscores.</summary>
    /// <remarks>Created once, because <see cref="Enum.ToString()"/> allocates.</remarks>
    /// <typeparam name="T">An enum whose values count from 0.</typeparam>
    sealed class EnumNames<T> where T : struct, Enum
    {
        static readonly T[] Values = (T[])Enum.GetValues(typeof(T));

        readonly Func<T, int> _numberOf;
        readonly string[] _names = Array.ConvertAll(Enum.GetNames(typeof(T)), Snake);

        /// <param name="numberOf">Converts a value to its number without an allocation.</param>
        /// <param name="first">Name of the first value, if it is not made from the enum.</param>
        public EnumNames(Func<T, int> numberOf, string first = null)
        {
            _numberOf = numberOf;
            _names[0] = first ?? _names[0];
        }

        /// <summary>The names in the order of the values.</summary>
        public IReadOnlyList<string> Names => _names;

        /// <summary>All names except an empty name, separated by commas, for messages.</summary>
        public string All => string.Join(", ", Array.FindAll(_names, name => name.Length > 0));

        public string NameOf(T value) => _names[_numberOf(value)];

        /// <param name="name">Name exactly as returned by <see cref="NameOf"/>.</param>
        /// <param name="value">The first value when the method returns false.</param>
        public bool TryParse(string name, out T value)
        {
            var index = Array.IndexOf(_names, name);
            value = Values[Math.Max(0, index)];
            return index >= 0;
        }

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
