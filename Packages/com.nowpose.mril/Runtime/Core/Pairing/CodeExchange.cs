using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Network;

namespace Nowpose.Pairing
{
    /// <summary>The gateway's code that was seen last and waits for a cell, and the exchange of one; never two at a time.</summary>
    sealed class CodeExchange : IDisposable
    {
        readonly string _headsetName;
        readonly Func<ConnectionSettings, string, CancellationToken, Task<PairingAnswer>> _send;
        readonly HashSet<string> _tried = new HashSet<string>(StringComparer.Ordinal);
        HeadsetTime _waitingUntil;
        TokenExchange _running;

        /// <param name="send">Must not block.</param>
        public CodeExchange(string headsetName, Func<ConnectionSettings, string, CancellationToken, Task<PairingAnswer>> send)
        {
            _headsetName = headsetName;
            _send = send;
        }

        /// <summary>Name of the cell that is being paired; null for none.</summary>
        public string Cell => _running?.Cell;

        /// <summary>Null for none.</summary>
        public TokenCode Waiting { get; private set; }

        /// <inheritdoc cref="TokenExchange.Trouble"/>
        public string Trouble => _running?.Trouble;

        /// <summary>Whether a gateway has judged it, or none answered while it was worth something.</summary>
        public bool WasTried(TokenCode code) => _tried.Contains(code.Token);

        public void Wait(TokenCode code, HeadsetTime now)
        {
            Waiting = code;
            _waitingUntil = now + PairingLimits.CodeValidity;
        }

        /// <param name="cell">What the waiting code is for; null for none so far.</param>
        /// <returns>Whether an exchange begins.</returns>
        public bool Offer(PairedCell cell, HeadsetTime now)
        {
            if (cell == null && now <= _waitingUntil) return false;
            if (cell != null) _running = new TokenExchange(cell, Waiting, _headsetName, now, _send);
            Waiting = null;
            return cell != null;
        }

        /// <returns>The last answer; null while there is none.</returns>
        public PairingAnswer Follow(HeadsetTime now)
        {
            var answer = _running?.Follow(now);
            // One that is cut short may be tried again: the gateway has perhaps not seen it.
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
