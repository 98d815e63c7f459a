using System.IO;
using Nowpose.Protocol;

namespace Nowpose.Network
{
    /// <summary>A message broke a limit in such a way that nothing tells where the next one begins: the connection has to end.</summary>
    sealed class MessageLimitException : IOException
    {
        public MessageLimitException(string message, DropReason reason, System.Exception innerException = null)
            : base(message, innerException) => Reason = reason;

        /// <summary>What to count.</summary>
        public DropReason Reason { get; }
    }
}
