using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Latency.Conditions;

namespace Nowpose.Latency.Sweep
{
    /// <summary>Writes a sweep's log while it runs, one load at a time and on another thread: no frame waits for the disk.</summary>
    /// <remarks>Belongs to one thread, but for what says otherwise. When the application dies the loads before the present one are in the file.</remarks>
    sealed class SweepFile
    {
        readonly int _rowsPerLoad;
        readonly DisplayConditions _conditions;
        readonly List<SweepRow> _written = new List<SweepRow>();
        List<SweepRow> _rows;
        Task _writing = Task.CompletedTask;
        volatile string _problem;

        /// <param name="path">Made with its folder when the first load ends; must not exist.</param>
        /// <param name="rowsPerLoad">For which room is made beforehand: adding that many allocates nothing.</param>
        /// <param name="conditions">Conditions of the sweep; null when nothing is known.</param>
        public SweepFile(string path, int rowsPerLoad, DisplayConditions conditions = null)
        {
            _conditions = conditions ?? DisplayConditions.Unknown;
            Path = path;
            _rowsPerLoad = rowsPerLoad;
            _rows = new List<SweepRow>(rowsPerLoad);
        }

        public string Path { get; }

        /// <summary>Why nothing more is written, in one line; null when nothing is wrong. Any thread.</summary>
        public string Problem => _problem;

        /// <summary>Rows beyond the room for a load are handed over, too: a load that lasts and lasts is not lost with the application.</summary>
        public void Add(in SweepRow row)
        {
            _rows.Add(row);
            if (_rows.Count >= _rowsPerLoad) EndLoad();
        }

        /// <summary>Hands the rows since the last call over to be written; returns at once.</summary>
        public void EndLoad()
        {
            var rows = _rows;
            _rows = new List<SweepRow>(_rowsPerLoad);
            Then(() => Write(rows));
        }

        /// <summary>Writes the rest and judges all of it; returns at once.</summary>
        /// <returns>Completes when the file does. Null when the file could not be written, and <see cref="Problem"/> says why.</returns>
        public Task<LoadSensitivity> CloseAsync()
        {
            EndLoad();
            LoadSensitivity judged = null;
            Then(() => judged = LoadSensitivity.Judge(_written));
            return _writing.ContinueWith(
                _ => judged, CancellationToken.None, TaskContinuationOptions.ExecuteSynchronously, TaskScheduler.Default);
        }

        // The scheduler is named because a caller's may be the frame's.
        void Then(Action action) => _writing = _writing.ContinueWith(
            _ => Try(action), CancellationToken.None, TaskContinuationOptions.None, TaskScheduler.Default);

        void Try(Action action)
        {
            if (_problem != null) return;
            try
            {
                action();
            }
            // Whatever it is: the sweep ends with a line, not the application.
            catch (Exception fault)
            {
                _problem = "sweep log " + Path + " cannot be written: " + fault.Message.Replace('\r', ' ').Replace('\n', ' ');
            }
        }

        void Write(List<SweepRow> rows)
        {
            if (rows.Count == 0) return;
            var isNew = _written.Count == 0;
            if (isNew) Directory.CreateDirectory(System.IO.Path.GetDirectoryName(System.IO.Path.GetFullPath(Path)));
            // Shared for writing, too: on Mono a reader that opens the file now holds on to the sharing that it found, and the next load would be
            // refused.
            using (var stream = new FileStream(Path, isNew ? FileMode.CreateNew : FileMode.Append, FileAccess.Write, FileShare.ReadWrite))
            using (var writer = new StreamWriter(stream))
            {
                if (isNew) SweepLog.WriteHeader(writer, _conditions);
                foreach (var row in rows) SweepLog.Write(writer, row);
            }
            _written.AddRange(rows);
        }
    }
}
