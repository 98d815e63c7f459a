using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Network;

namespace Nowpose.Pairing
{
    /// <summary>Keeps the newest gateway code until a cell needs it, and exchanges it for the headset's token, one exchange at a time.</summary>
    sealed class CodeExchange : IDisposable
    {
        readonly string _headsetName;
        readonly Func<ConnectionSettings, string, CancellationToken, Task<PairingAnswer>> _send;
        readonly HashSet<string> _tried = new HashSet<string>(StringComparer.Ordinal);
        HeadsetTime _waitingUntil;
        TokenExchange _running;

        /// <param name="send">Sends the token of the code to the gateway; must not block.</param>
        public CodeExchange(string headsetName, Func<ConnectionSettings, string, CancellationToken, Task<PairingAnswer>> send) =>
            (_headsetName, _send) = (headsetName, send);

        /// <summary>Name of the cell that is being paired; null if there is none.</summary>
        public string Cell => _running?.Cell;

        /// <summary>The code that waits for a cell; null if there is none.</summary>
        public TokenCode Waiting { get; private set; }

        /// <inheritdoc cref="TokenExchange.Trouble"/>
        public string Trouble => _running?.Trouble;

        /// <summary>Returns whether a gateway has accepted or rejected the code, or whether none responded while the code was valid.</summary>
        public bool WasTried(TokenCode code) => _tried.Contains(code.Token);

        public void Wait(TokenCode code, HeadsetTime now)
        {
            Waiting = code;
            _waitingUntil = now + PairingLimits.CodeValidity;
        }

        /// <param name="cell">The cell that needs the waiting code; null if there is none yet.</param>
        /// <returns>Whether an exchange starts.</returns>
        public bool Offer(PairedCell cell, HeadsetTime now)
        {
            if (cell == null && now <= _waitingUntil) return false;
            if (cell != null) _running = new TokenExchange(cell, Waiting, _headsetName, now, _send);
            Waiting = null;
            return cell != null;
        }

        /// <returns>The final response; null while there is none.</returns>
        public PairingAnswer Follow(HeadsetTime now)
        {
            var answer = _running?.Follow(now);
            // An interrupted exchange is not recorded, so that it can be repeated: the gateway may not have received the code.
            if (answer != null) _tried.Add(_running.Token);
            return answer;
        }

        public void End()
        {
            _running?.Dispose();
            _running = null;
        }

        public void Dispose() => End();
    }
}
