using Nowpose.Frames;
using Nowpose.Gateway.Hub;
using Nowpose.Protocol.Cell;

namespace Nowpose.Gateway.Plants;

/// <summary>Loads stationary objects from a file and publishes them on /tf_static.</summary>
static class StationaryFrames
{
    /// <summary>Reads and checks the file.</summary>
    /// <exception cref="InputException">The file cannot be read or is invalid, or its frames form a cycle.</exception>
    public static TransformsMessage Load(string path)
    {
        var message = StationaryFrameFile.Load(path);
        // Allows a parent that is not a frame of the file, because it may be a robot link, and the robots are not known yet.
        var parents = new FrameParents();
        for (var i = 0; i < message.Count; i++) Require(path, message[i], parents.TrySet(message[i].Child, message[i].Parent));
        return message;
    }

    /// <summary>Publishes the objects.</summary>
    /// <param name="path">Path of the file, for messages.</param>
    /// <exception cref="InputException">A frame belongs to another source or breaks a limit of the cell.</exception>
    public static void Publish(string path, TransformsMessage message, HubSource source)
    {
        var leftOut = new List<LeftOut>();
        source.Publish(message, isStationary: true, leftOut);
        if (leftOut.Count > 0) throw new InputException($"{path}: {leftOut[0].Fault}");
    }

    static void Require(string path, in FrameTransform frame, DropReason reason)
    {
        if (reason != DropReason.None)
            throw new InputException($"{path}: {CellMessageFaults.Of(CellMessageFaults.Frame(frame.Child, frame.Parent), reason)}");
    }
}
