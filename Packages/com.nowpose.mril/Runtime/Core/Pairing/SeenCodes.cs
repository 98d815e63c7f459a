using System;
using System.Collections.Generic;
using Nowpose.Messages;

namespace Nowpose.Pairing
{
    /// <summary>The pairing codes in view, each parsed once. Allocates nothing for a known code.</summary>
    sealed class SeenCodes
    {
        /// <summary>Maximum number of different codes at a time; further codes are ignored.</summary>
        public const int MaxCount = 256;

        /// <summary>
        /// Minimum time out of view after which a code may be dropped when the list is full. By then, a gateway's code has expired.
        /// </summary>
        static readonly TimeSpan Memory = PairingLimits.CodeValidity;

        readonly Dictionary<string, SeenCode> _codes = new Dictionary<string, SeenCode>(StringComparer.Ordinal);
        readonly List<string> _old = new List<string>();
        bool _isOversizedReported, _isFullReported;

        /// <param name="fault">The problem, reported once; null if there is none.</param>
        /// <returns>Null if the content is not a pairing code, or was not stored.</returns>
        public SeenCode Read(string text, HeadsetTime now, out string fault)
        {
            fault = null;
            var kind = PairingCode.KindOf(text);
            if (kind == PairingCodeKind.Foreign) return null;
            if (text.Length > PairingCode.MaxLength)
            {
                // An oversized text is not stored, because its source would otherwise determine the amount of memory used.
                if (!_isOversizedReported) fault = PairingCodeMessages.CodeTooLong(text.Length, PairingCode.MaxLength);
                _isOversizedReported = true;
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

        /// <summary>Forgets a code, so that its fault is reported again.</summary>
        public void Forget(string text)
        {
            if (text != null) _codes.Remove(text);
            _isOversizedReported = _isFullReported = false;
        }

        bool HasRoom(HeadsetTime now, out string fault)
        {
            fault = null;
            if (_codes.Count < MaxCount) return true;
            foreach (var code in _codes)
                if (now - code.Value.LastSeen > Memory) _old.Add(code.Key);
            foreach (var text in _old) _codes.Remove(text);
            _old.Clear();
            if (_codes.Count < MaxCount) return true;
            if (!_isFullReported)
                fault = PairingCodeMessages.TooManyInView(MaxCount, (int)Memory.TotalMinutes);
            _isFullReported = true;
            return false;
        }
    }
}
