using System.IO;

namespace Nowpose.Tests.Core.Recording
{
    /// <summary>
    /// Simulates a file on a disk with a limited number of free bytes. A write that does not fit fails. After a failed write, closing the file also
    /// fails.
    /// </summary>
    sealed class FullDisk : MemoryStream
    {
        readonly long _room;

        public FullDisk(long room) => _room = room;

        /// <summary>Number of failed writes.</summary>
        public int Refusals { get; private set; }

        public bool IsClosed { get; private set; }

        public override void Write(byte[] buffer, int offset, int count)
        {
            if (Length + count > _room) Refuse();
            base.Write(buffer, offset, count);
        }

        protected override void Dispose(bool disposing)
        {
            base.Dispose(disposing);
            if (IsClosed) return;
            IsClosed = true;
            // Closing a real file also fails while its buffer contains bytes that did not fit.
            if (Refusals > 0) Refuse();
        }

        void Refuse()
        {
            Refusals++;
            throw new IOException("No space left on device");
        }
    }
}
