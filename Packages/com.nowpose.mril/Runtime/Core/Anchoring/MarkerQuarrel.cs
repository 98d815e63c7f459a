using System;

namespace Nowpose.Anchoring
{
    /// <summary>Former name of <see cref="MarkerConflict"/>.</summary>
    [Obsolete("use MarkerConflict")]
    public sealed class MarkerQuarrel : MarkerConflict
    {
        internal MarkerQuarrel(BaseMarker marker, BaseMarker other, double metres, double radians) : base(marker, other, metres, radians) { }
    }
}
