using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using Nowpose.Latency.Conditions;
using Nowpose.Messages;

namespace Nowpose.Latency.Sweep
{
    /// <summary>Writes a sweep's log while it runs, load by load on another thread, so that no frame waits for the disk.</summary>
    /// <remarks>Single-threaded unless a member states otherwise. After a crash, the file contains all loads before the current load.</remarks>
    sealed class SweepFile
    {
        readonly int _rowsPerLoad;
        readonly DisplayConditions _conditions;
        readonly List<SweepRow> _written = new List<SweepRow>();
        List<SweepRow> _rows;
        Task _writing = Task.CompletedTask;
        volatile string _problem;

        /// <param name="path">Path of the file, which must not exist. It is created with its folder when the first load ends.</param>
        /// <param name="rowsPerLoad">Capacity in rows; adding up to this number per load allocates nothing.</param>
        /// <param name="conditions">Conditions of the sweep; null when they are unknown.</param>
        public SweepFile(string path, int rowsPerLoad, DisplayConditions conditions = null)
        {
            _conditions = conditions ?? DisplayConditions.Unknown;
            Path = path;
            _rowsPerLoad = rowsPerLoad;
            _rows = new List<SweepRow>(rowsPerLoad);
        }

        public string Path { get; }

        /// <summary>Error that stopped the writing, in one line; null if none has occurred. Can be read on any thread.</summary>
        public string Problem => _problem;

        /// <summary>Returns the path of a new log, whose name contains the start of the sweep in UTC.</summary>
        public static string NewPath(string folder, DateTime start) => System.IO.Path.Combine(
            folder, start.ToString("'nowpose-sweep-'yyyyMMdd'T'HHmmssfff'Z.csv'", CultureInfo.InvariantCulture));

        /// <summary>
        /// Adds a row. When the capacity is reached, writes the rows early, so that a crash during a very long load does not lose them.
        /// </summary>
        public void Add(in SweepRow row)
        {
            _rows.Add(row);
            if (_rows.Count >= _rowsPerLoad) EndLoad();
        }

        /// <summary>Queues the rows since the last call for writing and returns at once.</summary>
        public void EndLoad()
        {
            var rows = _rows;
            _rows = new List<SweepRow>(_rowsPerLoad);
            Then(() => Write(rows));
        }

        /// <summary>Queues the remaining rows and the evaluation of the sweep and returns at once.</summary>
        /// <returns>
        /// Task that completes when the file is written and the sweep is evaluated. Its result is null if the log could not be written; see
        /// <see cref="Problem"/>.
        /// </returns>
        public Task<LoadSensitivity> CloseAsync()
        {
            EndLoad();
            LoadSensitivity judged = null;
            Then(() => judged = LoadSensitivity.Judge(_written));
            return _writing.ContinueWith(
                _ => judged, CancellationToken.None, TaskContinuationOptions.ExecuteSynchronously, TaskScheduler.Default);
        }

        // The scheduler is explicit because the caller's current scheduler may run on the frame loop's thread.
        void Then(Action action) => _writing = _writing.ContinueWith(
            _ => Try(action), CancellationToken.None, TaskContinuationOptions.None, TaskScheduler.Default);

        void Try(Action action)
        {
            if (_problem != null) return;
            try
            {
                action();
            }
            // Catches every exception, so that it ends the sweep with a message and does not end the application.
            catch (Exception fault)
            {
                _problem = SweepMessages.LogNotWritten(Path, fault.Message.Replace('\r', ' ').Replace('\n', ' '));
            }
        }

        void Write(List<SweepRow> rows)
        {
            if (rows.Count == 0) return;
            var isNew = _written.Count == 0;
            if (isNew) Directory.CreateDirectory(System.IO.Path.GetDirectoryName(System.IO.Path.GetFullPath(Path)));
            // On Mono, a reader that opens the file keeps the sharing mode of the writer. The file is therefore also shared for writing;
            // otherwise such a reader would block the writing of the next load.
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
