using System.IO;

namespace Nowpose.Tests.Core.Recording
{
    /// <summary>A file on a disk that has room for so many bytes; what does not fit is refused, when it is closed, too.</summary>
    sealed class FullDisk : MemoryStream
    {
        readonly long _room;

        public FullDisk(long room) => _room = room;

        /// <summary>Writes that were refused.</summary>
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
            // As a file whose buffer still holds what found no room.
            if (Refusals > 0) Refuse();
        }

        void Refuse()
        {
            Refusals++;
            throw new IOException("No space left on device");
        }
    }
}
