using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Protocol;

namespace Nowpose.Network
{
    /// <summary>Messages between the thread that reads them and the one that takes them; beyond its room the oldest go, counted.</summary>
    sealed class ArrivedMessages
    {
        /// <summary>More than half a second of a robot that publishes at 100 Hz, at most 64 MiB of the longest messages.</summary>
        const int Room = 64;

        readonly Queue<ReceivedText> _waiting = new Queue<ReceivedText>();
        readonly object _gate = new object();
        TaskCompletionSource<bool> _more = NewSignal();
        int _lost;
        bool _hasEnded;
        Exception _failure;

        public void Add(ReceivedText message)
        {
            lock (_gate)
            {
                if (_hasEnded) return;
                _waiting.Enqueue(message);
                if (_waiting.Count > Room)
                {
                    _waiting.Dequeue();
                    _lost++;
                }
                _more.TrySetResult(true);
            }
        }

        /// <summary>Nothing comes any more; what waits is still handed out. Only the first end counts.</summary>
        /// <param name="failure">Why; null for an end in order.</param>
        public void End(Exception failure)
        {
            lock (_gate)
            {
                if (_hasEnded) return;
                _hasEnded = true;
                _failure = failure;
                _more.TrySetResult(true);
            }
        }

        /// <summary>The next message, as soon as there is one; null at the end. One caller at a time.</summary>
        /// <exception cref="Exception">What the end was told.</exception>
        public async Task<ReceivedText?> NextAsync(CancellationToken cancel)
        {
            ReceivedText? message;
            while (!TryTake(out message)) await _more.Task.OrCancelled(cancel).ConfigureAwait(false);
            return message;
        }

        bool TryTake(out ReceivedText? message)
        {
            message = null;
            lock (_gate)
            {
                if (_lost > 0)
                {
                    _lost--;
                    message = ReceivedText.Drop(DropReason.SlowReader, _waiting.Peek().Arrival);
                    return true;
                }
                if (_waiting.TryDequeue(out var waiting))
                {
                    message = waiting;
                    return true;
                }
                if (_failure != null) throw _failure;
                if (!_hasEnded && _more.Task.IsCompleted) _more = NewSignal();
                return _hasEnded;
            }
        }

        static TaskCompletionSource<bool> NewSignal() =>
            new TaskCompletionSource<bool>(TaskCreationOptions.RunContinuationsAsynchronously);
    }
}
