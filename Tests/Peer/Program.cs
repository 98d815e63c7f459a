using Nowpose.Peer;

// Usage: headset HOST SYNC_PORT WEBSOCKET_PORT PIN TOKEN | client URI PIN TOKEN ORIGIN   ("-" for none)
string Value(int i) => args[i] == "-" ? null : args[i];
switch (args[0])
{
    case "headset":
        HeadsetPeer.Run(args[1], int.Parse(args[2]), int.Parse(args[3]), Value(4), Value(5));
        return;
    case "client":
        await ClientPeer.RunAsync(new Uri(args[1]), Value(2), Value(3), Value(4));
        return;
    default:
        throw new ArgumentException($"unknown role {args[0]}");
}
