using System.Buffers.Binary;
using System.Collections.Immutable;
using System.Net.Sockets;
using System.Text;

namespace Nowpose.RtdeServer;

/// <summary>Serves one client: responds to its requests, and sends it the data of its recipe.</summary>
sealed class RtdeClient : IDisposable
{
    const int HeaderSize = 3;
    const byte OutputRecipe = 1;

    /// <summary>Time after which a client that does not read counts as disconnected.</summary>
    const int SendTimeoutMs = 1000;

    readonly Socket _socket;
    readonly RtdeServer _server;
    readonly Lock _sending = new();
    string[] _recipe = [];
    int _version = 1, _inputRecipes;
    double _intervalTicks = 1, _due;
    volatile bool _isStarted;
    bool _isBroken;

    /// <summary>The inputs that this client may write.</summary>
    public ImmutableHashSet<string> Inputs { get; private set; } = [];

    public RtdeClient(Socket socket, RtdeServer server)
    {
        _socket = socket;
        _server = server;
        socket.NoDelay = true;
        socket.SendTimeout = SendTimeoutMs;
    }

    /// <summary>Responds to requests until the client disconnects.</summary>
    public async Task RunAsync()
    {
        var bytes = new byte[ushort.MaxValue];
        try
        {
            await using var stream = new NetworkStream(_socket, ownsSocket: false);
            while (true)
            {
                await stream.ReadExactlyAsync(bytes.AsMemory(0, HeaderSize));
                var size = BinaryPrimitives.ReadUInt16BigEndian(bytes);
                if (size < HeaderSize) return;
                await stream.ReadExactlyAsync(bytes.AsMemory(HeaderSize, size - HeaderSize));
                Answer((PackageType)bytes[2], bytes.AsMemory(HeaderSize, size - HeaderSize));
            }
        }
        catch (Exception e) when (e is IOException or SocketException or ObjectDisposedException)
        {
            // The client has disconnected.
        }
    }

    /// <summary>
    /// Sends the data of one control cycle if the client requested them. Skips the cycle if the client has not read the previous data.
    /// </summary>
    public void SendCycle(long cycle, RobotState state)
    {
        if (!_isStarted || _isBroken || cycle < _due) return;
        // All clients with the same frequency receive the same cycles.
        _due = (Math.Floor(cycle / _intervalTicks) + 1) * _intervalTicks;
        if (!CanSend()) return;
        var package = new PackageWriter(PackageType.Data);
        if (_version == 2) package.Add(OutputRecipe);
        foreach (var field in _recipe) OutputFields.Write(field, package, state);
        Send(package, isHalf: _server.Fault == Fault.HalfPackages);
    }

    /// <summary>Sends bytes that are not an RTDE package.</summary>
    public void SendGarbage(ReadOnlySpan<byte> bytes)
    {
        if (CanSend()) Send(bytes);
    }

    public void Dispose() => _socket.Dispose();

    void Answer(PackageType type, ReadOnlyMemory<byte> payload)
    {
        if (_server.Fault is Fault.Silent or Fault.Garbage) return;
        switch (type)
        {
            case PackageType.ProtocolVersion:
                var requestedVersion = payload.Length == 2 ? BinaryPrimitives.ReadUInt16BigEndian(payload.Span) : 0;
                var isAccepted = requestedVersion == 1 || requestedVersion == 2 && _server.Fault != Fault.Version1;
                if (isAccepted) _version = requestedVersion;
                Send(new PackageWriter(type).Add(isAccepted));
                break;
            case PackageType.ControllerVersion:
                var (major, minor, bugfix, build) = _server.Version;
                Send(new PackageWriter(type).Add(major).Add(minor).Add(bugfix).Add(build));
                break;
            case PackageType.SetUpOutputs:
                SetUpOutputs(payload.Span);
                break;
            case PackageType.SetUpInputs:
                SetUpInputs(Names(payload.Span));
                break;
            case PackageType.Start:
                var canStart = _recipe.Length > 0;
                Send(new PackageWriter(type).Add(canStart));
                _isStarted = canStart;
                break;
            case PackageType.Pause:
                _isStarted = false;
                Send(new PackageWriter(type).Add(true));
                break;
            case PackageType.Data or PackageType.TextMessage:
                // The server ignores inputs.
                break;
            default:
                SendText($"unknown package type {(byte)type}");
                break;
        }
    }

    void SetUpInputs(string[] names)
    {
        var types = names.Select(name => _server.IsUsedByAnother(name, this) ? InputFields.InUse : InputFields.TypeOf(name)).ToArray();
        var isAccepted = !types.Any(type => type is InputFields.InUse or OutputFields.NotFound);
        if (isAccepted) Inputs = Inputs.Union(names);
        var id = isAccepted ? ++_inputRecipes : 0;
        Send(new PackageWriter(PackageType.SetUpInputs).Add((byte)id).Add(string.Join(',', types)));
    }

    void SetUpOutputs(ReadOnlySpan<byte> payload)
    {
        var frequency = _server.CyclesPerSecond;
        if (_version == 2 && payload.Length >= 8)
        {
            var wanted = BinaryPrimitives.ReadDoubleBigEndian(payload);
            if (wanted > 0 && wanted < frequency) frequency = wanted;
            payload = payload[8..];
        }

        var names = Names(payload);
        var types = names.Select(TypeOf).ToArray();
        _isStarted = false;
        _recipe = types.Contains(OutputFields.NotFound) ? [] : names;
        _intervalTicks = _server.CyclesPerSecond / frequency;
        _due = 0;
        var reply = new PackageWriter(PackageType.SetUpOutputs);
        if (_version == 2) reply.Add(_recipe.Length > 0 ? OutputRecipe : (byte)0);
        Send(reply.Add(string.Join(',', types)));
    }

    string TypeOf(string name) => name == "actual_q" && _server.Fault == Fault.NotFound ? OutputFields.NotFound
        : name == "actual_q" && _server.Fault == Fault.WrongType ? "VECTOR6INT32"
        : OutputFields.TypeOf(name);

    static string[] Names(ReadOnlySpan<byte> text) => Encoding.ASCII.GetString(text).Split(',', StringSplitOptions.TrimEntries);

    void SendText(string text)
    {
        const byte Warning = 2;
        const string Source = "RTDE";
        var package = new PackageWriter(PackageType.TextMessage);
        Send(_version == 2
            ? package.Add((byte)text.Length).Add(text).Add((byte)Source.Length).Add(Source).Add(Warning)
            : package.Add(Warning).Add(text));
    }

    // Another thread disposes the socket when the client disconnects.
    bool CanSend()
    {
        try
        {
            return _socket.Poll(0, SelectMode.SelectWrite);
        }
        catch (Exception e) when (e is SocketException or ObjectDisposedException)
        {
            return false;
        }
    }

    void Send(PackageWriter package, bool isHalf = false)
    {
        var bytes = package.Finish().Span;
        Send(isHalf ? bytes[..(bytes.Length / 2)] : bytes);
        _isBroken |= isHalf;
    }

    void Send(ReadOnlySpan<byte> bytes)
    {
        lock (_sending)
        {
            try
            {
                while (bytes.Length > 0) bytes = bytes[_socket.Send(bytes)..];
            }
            catch (Exception e) when (e is SocketException or ObjectDisposedException)
            {
                _isStarted = false;
                _socket.Dispose();
            }
        }
    }
}
