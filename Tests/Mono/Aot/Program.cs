using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Prediction;
using Nowpose.Sync;

namespace Nowpose.Mono.Aot
{
    /// <summary>Runs every part of Core that might need code generation at run time. The exit status is 1 if a part fails.</summary>
    static class Program
    {
        static int Main()
        {
            var failed = 0;
            foreach (var (name, check) in Checks())
            {
                try
                {
                    check();
                    Console.WriteLine("ok      " + name);
                }
                catch (Exception fault)
                {
                    failed++;
                    Console.WriteLine("FAILED  " + name + ": " + fault);
                }
            }
            Console.WriteLine(failed == 0 ? "all passed" : failed + " failed");
            return failed == 0 ? 0 : 1;
        }

        static IEnumerable<(string Name, Action Check)> Checks()
        {
            yield return ("URDF and kinematics", Robots.Check);
            yield return ("rosbridge and clock sync messages", Messages.Check);
            yield return ("pairing", Pairings.Check);
            yield return ("latency profile", Profiles.Check);
            yield return ("base from markers", Bases.Check);
            foreach (var estimator in ClockEstimators.Names)
                yield return ("session, clock " + estimator, () => Run("quadratic", estimator));
            foreach (var predictor in Predictors.Names.Append("linear-h4"))
                yield return ("session, predictor " + predictor, () => Run(predictor, ClockEstimators.Default));
        }

        static void Run(string predictor, string estimator)
        {
            using var session = new VirtualSession(predictor, estimator);
            session.Check();
        }

        /// <exception cref="InvalidOperationException">The condition does not hold.</exception>
        public static void Require(bool condition, string what)
        {
            if (!condition) throw new InvalidOperationException(what);
        }
    }
}
