using System;
using System.Buffers.Binary;
using System.Text;
using Nowpose.Messages;

namespace Nowpose.Protocol
{
    /// <summary>The data after a sync frame of kind <see cref="SyncFrameKind.Token"/>: a u16 length and that number of UTF-8 bytes.</summary>
    static class SyncToken
    {
        /// <summary>Size in bytes of the length field between frame and token.</summary>
        public const int LengthSize = 2;

        // Strict: rejects invalid UTF-8 instead of inserting replacement characters.
        static readonly UTF8Encoding Utf8 = new UTF8Encoding(false, true);

        /// <summary>Returns the frame, the length and the token in one buffer.</summary>
        /// <exception cref="InputException">The token is empty or longer than the protocol allows.</exception>
        public static byte[] Write(string token)
        {
            var length = RequireLength(token);
            var bytes = new byte[SyncFrame.Size + LengthSize + length];
            SyncFrame.Token().Write(bytes);
            BinaryPrimitives.WriteUInt16LittleEndian(bytes.AsSpan(SyncFrame.Size), (ushort)length);
            Utf8.GetBytes(token, 0, token.Length, bytes, SyncFrame.Size + LengthSize);
            return bytes;
        }

        /// <summary>Reads the length. Returns false if it is zero or exceeds the protocol's limit; the connection is then closed.</summary>
        public static bool TryReadLength(ReadOnlySpan<byte> bytes, out int length)
        {
            length = bytes.Length == LengthSize ? BinaryPrimitives.ReadUInt16LittleEndian(bytes) : 0;
            return length > 0 && length <= ProtocolLimits.TokenBytes;
        }

        /// <summary>Reads the token; returns false if the bytes are not UTF-8.</summary>
        public static bool TryReadText(ReadOnlySpan<byte> bytes, out string token)
        {
            token = null;
            try
            {
                token = Utf8.GetString(bytes);
                return true;
            }
            catch (DecoderFallbackException)
            {
                return false;
            }
        }

        /// <returns>Length of the token in bytes of UTF-8.</returns>
        /// <exception cref="InputException">The token is empty or longer than the protocol allows.</exception>
        internal static int RequireLength(string token)
        {
            var length = string.IsNullOrEmpty(token) ? 0 : Encoding.UTF8.GetByteCount(token);
            if (length == 0 || length > ProtocolLimits.TokenBytes)
                throw new InputException(ProtocolMessages.TokenLength(length, ProtocolLimits.TokenBytes));
            return length;
        }
    }
}
