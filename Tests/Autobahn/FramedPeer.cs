using System.Buffers.Binary;
using System.Threading.Channels;

namespace Nowpose.Headless.Tests.Autobahn;

/// <summary>The other end of a WebSocket at the level of bytes. Sends the chunks of a script, and reads frames until the connection ends.</summary>
/// <param name="goodbye">Called after a close frame has been received; ends the sending direction. Null to leave it open.</param>
sealed class FramedPeer(Stream stream, Action goodbye = null)
{
    readonly Channel<(int Opcode, byte[] Payload)> _frames = Channel.CreateUnbounded<(int, byte[])>();

    /// <summary>Received frames. The channel is completed when the connection ends.</summary>
    public ChannelReader<(int Opcode, byte[] Payload)> Frames => _frames.Reader;

    public async Task SendAsync(CaseScript script)
    {
        try
        {
            foreach (var chunk in script.Chunks)
            {
                await stream.WriteAsync(chunk);
                await stream.FlushAsync();
            }
            script.Chunks.Clear();
        }
        catch (Exception end) when (end is IOException or ObjectDisposedException)
        {
            // The other side has already closed the connection, which some cases expect.
        }
    }

    public async Task ReadAsync()
    {
        try
        {
            while (true)
            {
                var header = await ReadAsync(2);
                var length = header[1] & 0x7F;
                if (length == 126) length = BinaryPrimitives.ReadUInt16BigEndian(await ReadAsync(2));
                else if (length == 127) length = (int)BinaryPrimitives.ReadUInt64BigEndian(await ReadAsync(8));
                var mask = (header[1] & 0x80) != 0 ? await ReadAsync(4) : new byte[4];
                var payload = await ReadAsync(length);
                for (var i = 0; i < length; i++) payload[i] ^= mask[i & 3];
                _frames.Writer.TryWrite((header[0] & 0x0F, payload));
                if ((header[0] & 0x0F) == CaseScript.CloseFrame) goodbye?.Invoke();
            }
        }
        catch (Exception end) when (end is IOException or ObjectDisposedException)
        {
            _frames.Writer.Complete();
        }
    }

    async Task<byte[]> ReadAsync(int count)
    {
        var bytes = new byte[count];
        await stream.ReadExactlyAsync(bytes);
        return bytes;
    }
}
