using System.Buffers.Binary;
using System.Threading.Channels;

namespace Nowpose.Headless.Tests.Autobahn;

/// <summary>The other end of a WebSocket at the level of bytes. Sends the chunks of a script, and reads frames until the connection ends.</summary>
/// <remarks>
/// Answers pings, as RFC 6455 requires (5.5.2). The gateway sends messages only slowly to a client that does not answer pings, and then closes its
/// connection.
/// </remarks>
/// <param name="isMasked">Whether the pongs have a mask, as the frames of a client do.</param>
/// <param name="goodbye">Called after a close frame has been received; ends the sending direction. Null to leave it open.</param>
sealed class FramedPeer(Stream stream, bool isMasked, Action goodbye = null)
{
    // Held while a script is sent, so that a pong is not sent within a frame that is sent in pieces.
    readonly SemaphoreSlim _sending = new(1);
    readonly Channel<(int Opcode, byte[] Payload)> _frames = Channel.CreateUnbounded<(int, byte[])>();

    /// <summary>Received frames. The channel is completed when the connection ends.</summary>
    public ChannelReader<(int Opcode, byte[] Payload)> Frames => _frames.Reader;

    public async Task SendAsync(CaseScript script)
    {
        await _sending.WaitAsync();
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
        finally
        {
            _sending.Release();
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
                var opcode = header[0] & 0x0F;
                _frames.Writer.TryWrite((opcode, payload));
                if (opcode == CaseScript.Ping) await AnswerAsync(payload);
                if (opcode == CaseScript.CloseFrame) goodbye?.Invoke();
            }
        }
        catch (Exception end) when (end is IOException or ObjectDisposedException)
        {
            _frames.Writer.Complete();
        }
    }

    Task AnswerAsync(byte[] ping)
    {
        var pong = new CaseScript(isMasked, "", "");
        pong.Frame(CaseScript.Pong, ping);
        return SendAsync(pong);
    }

    async Task<byte[]> ReadAsync(int count)
    {
        var bytes = new byte[count];
        await stream.ReadExactlyAsync(bytes);
        return bytes;
    }
}
