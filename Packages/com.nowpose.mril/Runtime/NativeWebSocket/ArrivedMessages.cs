using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Protocol;

namespace Nowpose.Network
{
    /// <summary>Queue between the receiving thread and the consumer. Drops the oldest message when full, and reports each drop.</summary>
    sealed class ArrivedMessages
    {
        /// <summary>
        /// Queue capacity in messages: more than half a second of a robot that publishes at 100 Hz. A full queue of messages of maximum length takes
        /// 64 MiB.
        /// </summary>
        const int Capacity = 64;

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
                if (_waiting.Count > Capacity)
                {
                    _waiting.Dequeue();
                    _lost++;
                }
                _more.TrySetResult(true);
            }
        }

        /// <summary>Ends the queue. Queued messages are still delivered. Later calls have no effect.</summary>
        /// <param name="failure">Reason for the end; null if the connection was closed without an error.</param>
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

        /// <summary>Waits for the next message and returns it; returns null at the end of the queue. Supports one caller at a time.</summary>
        /// <exception cref="Exception">The queue has ended with a failure. The exception is the one passed to <see cref="End"/>.</exception>
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
