namespace Nowpose.Anchoring
{
    /// <summary>Why a sighting of one of the base's markers does not count.</summary>
    enum SightingFault
    {
        None,

        /// <summary>Its source does not follow it.</summary>
        NotTracked,

        /// <summary>Its pose is no numbers, or no rotation.</summary>
        NoPose,

        /// <summary>It is said to be at the application's origin, where devices put what they do not know.</summary>
        AtOrigin,

        /// <summary>It was seen too long ago, or in the future.</summary>
        Old,

        TooFar,
        TooOblique,

        /// <summary>It is behind the viewer's head, where no camera looks.</summary>
        Behind,

        /// <summary>Its edge is not as long as that of the marker of the base.</summary>
        OtherSize,

        /// <summary>The same code is seen in two places.</summary>
        TwoPlaces,
    }
}
