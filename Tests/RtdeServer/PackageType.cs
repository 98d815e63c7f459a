namespace Nowpose.RtdeServer;

/// <summary>Types of packages; each is an ASCII character.</summary>
enum PackageType : byte
{
    SetUpInputs = (byte)'I',
    TextMessage = (byte)'M',
    SetUpOutputs = (byte)'O',
    Pause = (byte)'P',
    Start = (byte)'S',
    Data = (byte)'U',
    ProtocolVersion = (byte)'V',
    ControllerVersion = (byte)'v',
}
