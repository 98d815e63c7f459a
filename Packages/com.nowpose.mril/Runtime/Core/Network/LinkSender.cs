using System;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Protocol;

namespace Nowpose.Network
{
    /// <summary>Lets several tasks send over a link that bears one sender.</summary>
    sealed class LinkSender : IDisposable
    {
        readonly IWebSocketLink _link;
        readonly IHeadsetClock _clock;
        readonly SemaphoreSlim _turn = new SemaphoreSlim(1);

        public LinkSender(IWebSocketLink link, IHeadsetClock clock)
        {
            _link = link;
            _clock = clock;
        }

        public void Dispose() => _turn.Dispose();

        /// <returns>When it was this text's turn: just before its first byte went out.</returns>
        /// <exception cref="IOException">The link took nothing for as long as it may be silent.</exception>
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
                    throw new IOException("nothing could be sent for " + ProtocolLimits.PongTimeout.TotalSeconds + " s", late);
                }
            }
        }

        async Task<HeadsetTime> SendInTurnAsync(string text, CancellationToken cancel)
        {
            await _turn.WaitAsync(cancel).ConfigureAwait(false);
            var begun = _clock.Now;
            // Whether the link heeds it or not: with a full buffer and nobody at the other end, a send may never come back.
            await _link.SendAsync(text, cancel).OrCancelled(cancel).ConfigureAwait(false);
            // Not after a failure: the link may still be at that text, and bears no other.
            _turn.Release();
            return begun;
        }
    }
}
