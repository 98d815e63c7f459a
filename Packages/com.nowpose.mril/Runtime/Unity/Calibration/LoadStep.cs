namespace Nowpose.Unity.Calibration
{
    /// <summary>What is done of a load in one go; each takes another time.</summary>
    enum LoadStep
    {
        /// <summary>Some of a patch's vertices and their triangles.</summary>
        Compute,

        /// <summary>A patch's vertices become those of a mesh.</summary>
        SetVertices,

        /// <summary>A patch's triangles too.</summary>
        SetTriangles,

        /// <summary>The mesh goes to the GPU and is shown.</summary>
        Show,
    }
}
