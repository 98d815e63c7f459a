using System;
using System.IO;
using Nowpose.Messages;

namespace Nowpose.Recording
{
    /// <summary>File and maximum size of a session recording. Immutable; checked in the constructor.</summary>
    public sealed class RecordingSettings
    {
        const int BufferBytes = 64 * 1024;

        /// <param name="path">Path of the file. Its folder is created if it does not exist, and an existing file is replaced.</param>
        /// <param name="maximumMegabytes">
        /// Maximum size, 0.001 to 100 000 MB of 10⁶ bytes; the recording ends there. A file always contains its header, even a larger one.
        /// </param>
        /// <param name="startedUtc">Start time for the header, to identify old files; null to omit it.</param>
        /// <exception cref="InputException">A value is out of range, or the path is empty.</exception>
        public RecordingSettings(string path, double maximumMegabytes = 500, DateTime? startedUtc = null)
            : this(path, () => OpenFile(path), maximumMegabytes, startedUtc)
        {
        }

        /// <param name="name">Name used in messages instead of the path.</param>
        /// <param name="open">Opens the stream. Called once, on the recording's own thread, which also disposes of the stream.</param>
        /// <param name="maximumMegabytes">See the other constructor.</param>
        /// <param name="startedUtc">See the other constructor.</param>
        /// <exception cref="InputException">A value is out of range, or the name is empty.</exception>
        public RecordingSettings(string name, Func<Stream> open, double maximumMegabytes = 500, DateTime? startedUtc = null)
        {
            if (string.IsNullOrWhiteSpace(name)) throw new InputException(RecordingMessages.NoPath);
            Path = name;
            Open = open ?? throw new ArgumentNullException(nameof(open));
            MaximumBytes = (long)(SettingRange.Require(maximumMegabytes, 0.001, 100_000, SettingNames.MaxRecordingSize, "MB") * 1e6);
            StartedUtc = startedUtc;
        }

        public string Path { get; }
        public long MaximumBytes { get; }
        public DateTime? StartedUtc { get; }

        internal Func<Stream> Open { get; }

        static FileStream OpenFile(string path)
        {
            var folder = System.IO.Path.GetDirectoryName(System.IO.Path.GetFullPath(path));
            if (!string.IsNullOrEmpty(folder)) Directory.CreateDirectory(folder);
            // Other programs may read the file while it grows.
            return new FileStream(path, FileMode.Create, FileAccess.Write, FileShare.Read, BufferBytes);
        }
    }

    /// <summary>State of a recording. It never returns to <see cref="Recording"/>.</summary>
    public enum RecordingState
    {
        Recording,

        /// <summary>The recording ended because the recorder was disposed; the file is complete.</summary>
        Closed,

        /// <summary>The recording ended at the maximum size; the file contains all earlier records.</summary>
        Full,

        /// <summary>
        /// The recording ended because the file cannot be written (no permission, disk full, device removed); the written part remains.
        /// </summary>
        Failed,
    }
}
