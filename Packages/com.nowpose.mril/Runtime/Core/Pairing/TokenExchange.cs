using System;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Messages;
using Nowpose.Network;

namespace Nowpose.Pairing
{
    /// <summary>Sends one code's token until the gateway has accepted or rejected it, the code has expired, or the exchange is disposed.</summary>
    sealed class TokenExchange : IDisposable
    {
        readonly ConnectionSettings _gateway;
        readonly Func<ConnectionSettings, string, CancellationToken, Task<PairingAnswer>> _send;
        readonly CancellationTokenSource _cancel = new CancellationTokenSource();
        readonly HeadsetTime _lastStart;
        HeadsetTime _nextStart;
        Task<PairingAnswer> _running;

        /// <param name="send">Sends the token of the code to the gateway; must not block.</param>
        public TokenExchange(
            PairedCell cell, TokenCode code, string headsetName, HeadsetTime now,
            Func<ConnectionSettings, string, CancellationToken, Task<PairingAnswer>> send)
        {
            Cell = cell.Cell;
            _gateway = cell.Newest.ToConnection(null, headsetName);
            Token = code.Token;
            _send = send;
            _nextStart = now;
            _lastStart = now + PairingLimits.CodeValidity;
        }

        public string Cell { get; }

        /// <summary>Token of the code. Secret.</summary>
        public string Token { get; }

        /// <summary>Reason why the last attempt failed, with a note that it is repeated; null if no attempt has failed.</summary>
        public string Trouble { get; private set; }

        /// <returns>The final response; null until there is one.</returns>
        public PairingAnswer Follow(HeadsetTime now)
        {
            if (_running == null && now >= _nextStart) _running = _send(_gateway, Token, _cancel.Token);
            if (_running == null || !_running.IsCompleted) return null;
            var answer = _running.IsFaulted || _running.IsCanceled
                ? PairingAnswer.Refused(_running.Exception?.GetBaseException().Message ?? PairingAnswerMessages.Cancelled) : _running.Result;
            _running = null;
            _nextStart = now + PairingLimits.RetryInterval;
            if (!answer.IsWorthRetrying || _nextStart > _lastStart) return answer;
            Trouble = answer.Problem + "; trying again";
            return null;
        }

        public void Dispose()
        {
            _cancel.Cancel();
            _cancel.Dispose();
        }
    }
}
