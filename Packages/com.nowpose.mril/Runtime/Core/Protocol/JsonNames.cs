using System;
using System.Text;

namespace Nowpose.Protocol
{
    /// <summary>A few known strings in UTF-8, for comparison with received JSON without creating string objects.</summary>
    sealed class JsonNames
    {
        readonly string[] _names;
        readonly byte[][] _utf8;

        public JsonNames(params string[] names)
        {
            _names = names;
            _utf8 = Array.ConvertAll(names, Encoding.UTF8.GetBytes);
        }

        public string this[int index] => _names[index];

        /// <returns>Index of the string; -1 if it is not one of the known strings.</returns>
        public int IndexOf(ReadOnlySpan<byte> utf8)
        {
            for (var i = 0; i < _utf8.Length; i++)
                if (utf8.SequenceEqual(_utf8[i])) return i;
            return -1;
        }
    }
}
