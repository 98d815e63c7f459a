using System;
using System.Collections.Generic;

namespace Nowpose.Pairing
{
    /// <summary>The codes of ours that were in view, each read once. Allocates nothing for one that is known.</summary>
    sealed class SeenCodes
    {
        /// <summary>Different codes at a time; whoever hangs up more is not listened to.</summary>
        public const int GreatestCount = 256;

        /// <summary>One that was out of view for so long makes room where there is none: a gateway's code is worth nothing then.</summary>
        static readonly TimeSpan Memory = PairingLimits.CodeValidity;

        readonly Dictionary<string, SeenCode> _codes = new Dictionary<string, SeenCode>(StringComparer.Ordinal);
        readonly List<string> _old = new List<string>();
        bool _isOversizedTold, _isFullTold;

        /// <param name="fault">What is wrong, told once; null for nothing.</param>
        /// <returns>Null where it is none of ours, or not kept.</returns>
        public SeenCode Read(string text, HeadsetTime now, out string fault)
        {
            fault = null;
            var kind = PairingCode.KindOf(text);
            if (kind == PairingCodeKind.Foreign) return null;
            if (text.Length > PairingCode.GreatestLength)
            {
                // Not remembered: it would be the room that somebody else decides on.
                if (!_isOversizedTold) fault = "pairing code: " + text.Length + " characters; allowed are up to " + PairingCode.GreatestLength;
                _isOversizedTold = true;
                return null;
            }
            if (!_codes.TryGetValue(text, out var code))
            {
                if (!HasRoom(now, out fault)) return null;
                _codes.Add(text, code = SeenCode.Read(text, kind));
                fault = code.Fault;
            }
            code.LastSeen = now;
            return code;
        }

        bool HasRoom(HeadsetTime now, out string fault)
        {
            fault = null;
            if (_codes.Count < GreatestCount) return true;
            foreach (var code in _codes)
                if (now - code.Value.LastSeen > Memory) _old.Add(code.Key);
            foreach (var text in _old) _codes.Remove(text);
            _old.Clear();
            if (_codes.Count < GreatestCount) return true;
            if (!_isFullTold)
                fault = "pairing codes: " + GreatestCount + " different ones were in view; others are read again in "
                    + (int)Memory.TotalMinutes + " minutes, or after a restart";
            _isFullTold = true;
            return false;
        }
    }
}
