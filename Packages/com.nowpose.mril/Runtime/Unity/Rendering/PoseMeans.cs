namespace Nowpose.Unity.Rendering
{
    /// <summary>How a material can show that a pose is not current.</summary>
    enum PoseMeans
    {
        /// <summary>The shader declares <c>_Fade</c> and <c>_Hatch</c>.</summary>
        Pattern,

        /// <summary>The material is blended by its alpha (according to <c>_SrcBlend</c> or its tag), and the shader has a colour.</summary>
        Alpha,

        /// <summary>Neither: the part is drawn with another material, or hidden.</summary>
        None,

        /// <summary>It writes no colour, so it looks the same in every state.</summary>
        NotNeeded,
    }
}
