using System;

namespace Nowpose.Simulation
{
    /// <summary>Random numbers of distributions that <see cref="Random"/> does not have.</summary>
    static class RandomNumbers
    {
        /// <summary>Returns a random number of the standard normal distribution, from two uniform numbers (Box and Muller).</summary>
        public static double NextNormal(this Random random) =>
            Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
    }
}
