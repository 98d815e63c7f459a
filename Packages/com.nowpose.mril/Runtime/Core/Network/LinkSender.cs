using System;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Messages;
using Nowpose.Protocol;

namespace Nowpose.Network
{
    /// <summary>Serialises the sends of several tasks over a link that supports one sender.</summary>
    sealed class LinkSender : IDisposable
    {
        readonly IWebSocketLink _link;
        readonly IHeadsetClock _clock;
        readonly SemaphoreSlim _turn = new SemaphoreSlim(1);

        public LinkSender(IWebSocketLink link, IHeadsetClock clock) => (_link, _clock) = (link, clock);

        public void Dispose() => _turn.Dispose();

        /// <returns>Time just before the first byte of the message was sent.</returns>
        /// <exception cref="IOException">The message could not be sent within the timeout.</exception>
        public async Task<HeadsetTime> SendAsync(string text, CancellationToken cancel)
        {
            using (var inTime = CancellationTokenSource.CreateLinkedTokenSource(cancel))
            {
                inTime.CancelAfter(ProtocolLimits.PongTimeout);
                try
                {
                    return await SendInTurnAsync(text, inTime.Token).ConfigureAwait(false);
                }
                catch (OperationCanceledException late) when (!cancel.IsCancellationRequested)
                {
                    throw new IOException(ConnectionMessages.NothingSent(ProtocolLimits.PongTimeout.TotalSeconds), late);
                }
            }
        }

        async Task<HeadsetTime> SendInTurnAsync(string text, CancellationToken cancel)
        {
            await _turn.WaitAsync(cancel).ConfigureAwait(false);
            var begun = _clock.Now;
            // OrCancelled also returns if the link ignores the cancellation: with a full buffer and a lost peer, a send may never complete.
            await _link.SendAsync(text, cancel).OrCancelled(cancel).ConfigureAwait(false);
            // The semaphore is not released after a failure, because the link may still be sending that message and supports only one send at a time.
            _turn.Release();
            return begun;
        }
    }
}
