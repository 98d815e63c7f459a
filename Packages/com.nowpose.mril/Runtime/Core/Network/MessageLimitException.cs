using System.IO;
using Nowpose.Protocol;

namespace Nowpose.Network
{
    /// <summary>A message exceeded a limit such that the start of the next message is unknown; the connection has to end.</summary>
    sealed class MessageLimitException : IOException
    {
        public MessageLimitException(string message, DropReason reason, System.Exception innerException = null)
            : base(message, innerException) => Reason = reason;

        /// <summary>The reason to count.</summary>
        public DropReason Reason { get; }
    }
}
