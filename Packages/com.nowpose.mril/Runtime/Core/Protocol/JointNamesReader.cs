using System;
using System.Collections.Generic;

namespace Nowpose.Protocol
{
    /// <summary>Reads a message's joint names. Returns a cached array if the bytes are the same as before. Not thread-safe.</summary>
    sealed class JointNamesReader
    {
        /// <summary>Number of cached arrays: an arm, a gripper and a few axes may publish alternately.</summary>
        const int Capacity = 4;

        readonly (byte[] Text, string[] Names)[] _known = new (byte[], string[])[Capacity];
        int _next;

        public bool Read(ref JsonUtf8Reader json, out string[] names)
        {
            foreach (var known in _known)
            {
                names = known.Names;
                if (names != null && json.TryTake(known.Text)) return true;
            }

            var start = json.Position;
            if (!ReadNew(ref json, out names)) return false;
            _known[_next] = (json.Since(start).ToArray(), names);
            _next = (_next + 1) % Capacity;
            return true;
        }

        static bool ReadNew(ref JsonUtf8Reader json, out string[] names)
        {
            names = Array.Empty<string>();
            var read = new List<string>();
            var known = new HashSet<string>(StringComparer.Ordinal);
            if (!json.BeginArray()) return false;
            while (json.NextElement() && json.Name(out var name))
            {
                read.Add(name);
                if (read.Count > ProtocolLimits.Joints) return json.Fail(DropReason.TooManyJoints);
                if (!known.Add(name)) return json.Fail(DropReason.DuplicateName);
            }

            names = read.ToArray();
            return json.Fault == DropReason.None;
        }
    }
}
