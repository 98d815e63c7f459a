namespace Nowpose.Unity.Rendering
{
    /// <summary>Means by which a material can mark a pose as not current.</summary>
    enum PoseMeans
    {
        /// <summary>Fade and stripes: the shader declares <c>_Fade</c> and <c>_Hatch</c>.</summary>
        Pattern,

        /// <summary>
        /// A lower alpha: the material is blended by its alpha, according to <c>_SrcBlend</c> or its tag, and its shader has a colour.
        /// </summary>
        Alpha,

        /// <summary>None: the part must be drawn with another material, or hidden.</summary>
        None,

        /// <summary>None is needed: the material writes no colour, so the part is invisible in every state.</summary>
        NotNeeded,
    }
}
