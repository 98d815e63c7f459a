using System;
using System.Collections.Concurrent;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Text;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Messages;

namespace Nowpose.Recording
{
    /// <summary>Writes records as lines of a file, on its own thread, which is the only thread that waits for the disk.</summary>
    sealed class RecordWriter
    {
        /// <summary>Space reserved for the last line, which states why the file ends.</summary>
        const int LastLineBytes = 100;

        static readonly TimeSpan PollInterval = TimeSpan.FromMilliseconds(50);

        /// <summary>Maximum time span of the data that are lost if the process crashes.</summary>
        static readonly TimeSpan FlushInterval = TimeSpan.FromSeconds(1);

        readonly RecordingSettings _settings;
        readonly RecordRing _ring;
        readonly JsonLine _line;
        readonly RecordLine _recordLine;
        readonly object _gate = new object();
        readonly ConcurrentQueue<TaskCompletionSource<bool>> _flushes = new ConcurrentQueue<TaskCompletionSource<bool>>();
        readonly Stopwatch _sinceFlush = Stopwatch.StartNew();
        byte[] _bytes = new byte[4096];
        volatile bool _isStopping;
        volatile string _problem;
        volatile RecordingState _state;
        long _written, _lostWritten;

        /// <param name="line">Line buffer, which already contains the first line.</param>
        /// <param name="recordLine">Writes records into <paramref name="line"/>.</param>
        public RecordWriter(RecordingSettings settings, RecordRing ring, JsonLine line, RecordLine recordLine) =>
            (_settings, _ring, _line, _recordLine) = (settings, ring, line, recordLine);

        public RecordingState State => _state;

        /// <summary>Reason why the recording ended before it was stopped, in one line; null otherwise.</summary>
        public string Problem => _problem;

        public long Written => Interlocked.Read(ref _written);

        public Task Ended { get; private set; }

        // The scheduler is explicit because the caller's scheduler may run on the frame loop's thread.
        public void Start() => Ended = Task.Factory.StartNew(Run, CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default);

        /// <summary>Stops after writing the records that are in the ring now; returns at once.</summary>
        public void Stop()
        {
            _isStopping = true;
            Wake();
        }

        /// <summary>Completes when the records that are in the ring now are in the file, or the recording has ended.</summary>
        public Task FlushAsync()
        {
            var flush = new TaskCompletionSource<bool>(TaskCreationOptions.RunContinuationsAsynchronously);
            _flushes.Enqueue(flush);
            Wake();
            if (_state != RecordingState.Recording) CompleteFlushes();
            return flush.Task;
        }

        void Run()
        {
            Thread.CurrentThread.Name = "Nowpose recording";
            try
            {
                using (var stream = _settings.Open()) WriteAll(stream);
                _state = _problem == null ? RecordingState.Closed : RecordingState.Full;
            }
            // Catches every exception, because an uncaught exception would end the application.
            catch (Exception failure)
            {
                _problem = RecordingMessages.Stopped(_settings.Path, failure.Message.Replace('\r', ' ').Replace('\n', ' '));
                _state = RecordingState.Failed;
            }
            CompleteFlushes();
        }

        void WriteAll(Stream stream)
        {
            // A file without its header cannot be read, so the header is written even if it is larger than the maximum size.
            Put(stream);
            for (var isLast = false; !isLast;)
            {
                isLast = _isStopping;
                // Counts the requests before the ring is emptied, because later requests may refer to later records.
                var asked = _flushes.Count;
                if (!TryDrain(stream))
                {
                    _problem = RecordingMessages.MaxSize(_settings.Path, (_settings.MaximumBytes / 1e6).ToString("0.###", CultureInfo.InvariantCulture));
                    break;
                }
                if (asked > 0 || _sinceFlush.Elapsed >= FlushInterval) Flush(stream, asked);
                if (!isLast) Wait();
            }
            _line.Begin("end").Add("reason", _problem == null ? "closed" : "full").End();
            Put(stream);
        }

        bool TryDrain(Stream stream)
        {
            while (_ring.TryPeek(out var record))
            {
                _recordLine.Write(record);
                _ring.Release();
                if (!TryPut(stream)) return false;
            }
            var lost = _ring.Lost;
            if (lost == _lostWritten) return true;
            _line.Begin("lost").Add("count", lost - _lostWritten).End();
            _lostWritten = lost;
            return TryPut(stream);
        }

        bool TryPut(Stream stream)
        {
            if (Written + Encoding.UTF8.GetMaxByteCount(_line.Text.Length) > _settings.MaximumBytes - LastLineBytes
                && Written + Encoding.UTF8.GetByteCount(_line.Text) > _settings.MaximumBytes - LastLineBytes) return false;
            Put(stream);
            return true;
        }

        void Put(Stream stream)
        {
            var most = Encoding.UTF8.GetMaxByteCount(_line.Text.Length);
            if (_bytes.Length < most) _bytes = new byte[most];
            var count = Encoding.UTF8.GetBytes(_line.Text, _bytes);
            stream.Write(_bytes, 0, count);
            Interlocked.Add(ref _written, count);
        }

        void Flush(Stream stream, int asked)
        {
            stream.Flush();
            _sinceFlush.Restart();
            for (; asked > 0 && _flushes.TryDequeue(out var flush); asked--) flush.SetResult(true);
        }

        void Wake()
        {
            lock (_gate) Monitor.Pulse(_gate);
        }

        // Records do not wake the thread, because a wake-up would cost the frame a system call.
        void Wait()
        {
            lock (_gate)
                if (!_isStopping && _flushes.IsEmpty) Monitor.Wait(_gate, PollInterval);
        }

        void CompleteFlushes()
        {
            while (_flushes.TryDequeue(out var flush)) flush.SetResult(true);
        }
    }
}
