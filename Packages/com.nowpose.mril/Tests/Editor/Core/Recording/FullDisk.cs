using System.IO;

namespace Nowpose.Tests.Core.Recording
{
    /// <summary>A file on a disk with a limited number of free bytes. A write that does not fit fails, and so does closing the file then.</summary>
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
            // Like a file whose buffer still holds the bytes that did not fit.
            if (Refusals > 0) Refuse();
        }

        void Refuse()
        {
            Refusals++;
            throw new IOException("No space left on device");
        }
    }
}
