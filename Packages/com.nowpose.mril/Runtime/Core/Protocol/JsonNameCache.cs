using System;

namespace Nowpose.Protocol
{
    /// <summary>
    /// Returns the same string for the same received name, so that repeated names create no garbage. Limited size; not thread-safe.
    /// </summary>
    sealed class JsonNameCache
    {
        /// <summary>
        /// Maximum length of a cached name in bytes: a namespace, a slash, and a name with at most 3 bytes of UTF-8 per UTF-16 code unit.
        /// </summary>
        const int MaxBytes = ProtocolLimits.NamespaceLength + 1 + 3 * ProtocolLimits.NameLength;

        readonly int _capacity;
        // Created when the first name is read, because some readers read no names.
        (byte[] Utf8, string Text)[] _table;
        int _count;

        /// <param name="capacity">Maximum number of names. When it is reached, the cache is cleared.</param>
        public JsonNameCache(int capacity) => _capacity = capacity;

        public string this[JsonText name]
        {
            get
            {
                if (name.IsEscaped || name.Raw.Length > MaxBytes) return name.ToString();
                _table ??= new (byte[], string)[SizeFor(_capacity)];
                var place = Find(name.Raw);
                if (_table[place].Text != null) return _table[place].Text;
                if (_count == _capacity)
                {
                    Array.Clear(_table, 0, _table.Length);
                    _count = 0;
                    place = Find(name.Raw);
                }

                _count++;
                _table[place] = (name.Raw.ToArray(), name.ToString());
                return _table[place].Text;
            }
        }

        static int SizeFor(int capacity)
        {
            var size = 4;
            while (size < 2 * capacity) size *= 2;
            return size;
        }

        // Returns the index of the name, or of the free place for it. The table is never full.
        int Find(ReadOnlySpan<byte> utf8)
        {
            var place = Hash(utf8) & (_table.Length - 1);
            while (_table[place].Text != null && !utf8.SequenceEqual(_table[place].Utf8)) place = (place + 1) & (_table.Length - 1);
            return place;
        }

        // FNV-1a.
        static int Hash(ReadOnlySpan<byte> utf8)
        {
            unchecked
            {
                var hash = 2166136261u;
                foreach (var value in utf8) hash = (hash ^ value) * 16777619u;
                return (int)(hash ^ (hash >> 15));
            }
        }
    }
}
