using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Protocol;

namespace Nowpose.Network
{
    /// <summary>Queue between the receiving thread and the consumer. Drops the oldest message when full, and counts it.</summary>
    sealed class ArrivedMessages
    {
        /// <summary>Capacity: more than half a second of a robot that publishes at 100 Hz; at most 64 MiB for messages of maximum length.</summary>
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

        /// <summary>Ends the queue; waiting messages are still delivered. Only the first call counts.</summary>
        /// <param name="failure">The reason; null for an orderly end.</param>
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

        /// <summary>Returns the next message as soon as there is one; null at the end. One caller at a time.</summary>
        /// <exception cref="Exception">The failure passed to <see cref="End"/>.</exception>
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
