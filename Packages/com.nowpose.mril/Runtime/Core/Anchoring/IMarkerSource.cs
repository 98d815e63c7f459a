using System.Collections.Generic;

namespace Nowpose.Anchoring
{
    /// <summary>Tells which markers are in the room: a device's finder of codes, a hand that places one, a recording.</summary>
    public interface IMarkerSource
    {
        /// <summary>Adds all markers that are known at the moment, each once; what is in the list stays. Never throws.</summary>
        /// <remarks>Asked once a frame, on its thread: quick, and without allocating where no marker is new.</remarks>
        void Read(List<MarkerSighting> markers);
    }
}
